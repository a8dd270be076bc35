// The page of words that contains all views of a call.

@group(0) @binding(2) var<storage, read> page_0: array<u32>;

fn word(page: u32, at: u32) -> u32 {
    return page_0[at];
}
