// All pages of words.

@group(0) @binding(2) var<storage, read> page_0: array<u32>;
@group(0) @binding(3) var<storage, read> page_1: array<u32>;
@group(0) @binding(4) var<storage, read> page_2: array<u32>;
@group(0) @binding(5) var<storage, read> page_3: array<u32>;

fn word(page: u32, at: u32) -> u32 {
    switch page {
        case 0u: { return page_0[at]; }
        case 1u: { return page_1[at]; }
        case 2u: { return page_2[at]; }
        default: { return page_3[at]; }
    }
}
