/** `<parkade-playground>` in JSX of Solid: `import type {} from "parkade/element/solid"`. */
import type { JSX } from "solid-js";
import type { ParkadePlayground, PlaygroundAttributes } from "../element.js";

declare module "solid-js" {
  namespace JSX {
    interface IntrinsicElements {
      "parkade-playground": Omit<JSX.HTMLAttributes<ParkadePlayground>, keyof PlaygroundAttributes> &
        PlaygroundAttributes;
    }
  }
}
