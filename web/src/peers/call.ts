/** A connection of WebRTC to one other page, with one channel for data, which both pages make. */
import type { Clock } from '../rooms/clock';
import type { Line } from './peer';

/** Seconds in which the browser must know its own addresses. */
const ADDRESSES = 1;
/** The channel of both pages. Files come in order and whole. */
const CHANNEL = { negotiated: true, id: 0, ordered: true } as const;

export interface CallEvents {
  /** The channel can be used. */
  readonly opened: (line: Line) => void;
  /** The connection has ended, or does not come about. */
  readonly ended: () => void;
  /** The other page has broken the rules. */
  readonly refuse: (sentence: string) => void;
}

export interface Call {
  /** A description of this page's end. */
  offer(): Promise<string>;
  /** The answer to an offer. */
  answer(offer: string): Promise<string>;
  /** The other page has answered. */
  take(answer: string): Promise<void>;
  close(): void;
}

export function createCall({ opened, ended, refuse }: CallEvents, later: Clock['later']): Call {
  // No server tells addresses: pages reach each other in one network, or where they have public ones.
  const connection = new RTCPeerConnection({ iceServers: [] });
  const channel = connection.createDataChannel('files', CHANNEL);
  channel.onopen = () => opened(channel);
  channel.onclose = ended;
  connection.ondatachannel = () => refuse('it opens another channel');
  connection.onconnectionstatechange = () => {
    if (['failed', 'closed'].includes(connection.connectionState)) ended();
  };

  /** Descriptions with all addresses, so that one signal suffices. */
  async function described(): Promise<string> {
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
    offer: described,
    async answer(offer) {
      await connection.setRemoteDescription({ type: 'offer', sdp: offer });
      return described();
    },
    take: (answer) => connection.setRemoteDescription({ type: 'answer', sdp: answer }),
    close() {
      channel.onclose = connection.onconnectionstatechange = null;
      connection.close();
    },
  };
}
