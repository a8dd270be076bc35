/** WebRTC connection to one other page with one data channel, which both pages create. */
import type { Clock } from '../rooms/clock';
import type { Line } from './peer';

/** Timeout in seconds for gathering the browser's own addresses. */
const ADDRESSES = 1;
/** Settings of the data channel that both pages share. It is reliable and ordered. */
const CHANNEL = { negotiated: true, id: 0, ordered: true } as const;

export interface CallEvents {
  /** Called when the channel can be used. */
  readonly opened: (line: Line) => void;
  /** Called when the connection has ended or could not be established. */
  readonly ended: () => void;
  /** Called when the other page violates the protocol. */
  readonly refuse: (sentence: string) => void;
}

export interface Call {
  /** Returns this page's offer. */
  offer(): Promise<string>;
  /** Returns the answer to an offer. */
  answer(offer: string): Promise<string>;
  /** Applies the other page's answer. */
  take(answer: string): Promise<void>;
  close(): void;
}

export function createCall({ opened, ended, refuse }: CallEvents, later: Clock['later']): Call {
  // There is no STUN server: pages connect in a local network, or if they have public addresses.
  const connection = new RTCPeerConnection({ iceServers: [] });
  const channel = connection.createDataChannel('files', CHANNEL);
  channel.onopen = () => opened(channel);
  channel.onclose = ended;
  connection.ondatachannel = () => refuse('it opens another channel');
  connection.onconnectionstatechange = () => {
    if (['failed', 'closed'].includes(connection.connectionState)) ended();
  };

  /** Returns the description with all addresses, so that one signal suffices. */
  async function localDescription(): Promise<string> {
    await connection.setLocalDescription();
    if (connection.iceGatheringState !== 'complete') {
      await new Promise<void>((done) => {
        const stop = later(ADDRESSES, done);
        connection.onicegatheringstatechange = () => {
          if (connection.iceGatheringState !== 'complete') return;
          stop();
          done();
        };
      });
    }
    return connection.localDescription?.sdp ?? '';
  }

  return {
    offer: localDescription,
    async answer(offer) {
      await connection.setRemoteDescription({ type: 'offer', sdp: offer });
      return localDescription();
    },
    take: (answer) => connection.setRemoteDescription({ type: 'answer', sdp: answer }),
    close() {
      channel.onclose = connection.onconnectionstatechange = null;
      connection.close();
    },
  };
}
