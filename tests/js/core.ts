import * as small from "parkade/core";

/** The small module under the types of the whole package: what it lacks, and what it refuses, is tested at run time. */
export const core = small as unknown as typeof import("parkade");
