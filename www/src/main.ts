import { Playground } from "./element/playground";

// Pages that embed load this file as a part of theirs; there the name is the embedded element's.
if (!customElements.get("parkade-playground")) customElements.define("parkade-playground", Playground);
