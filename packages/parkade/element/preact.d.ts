/** `<parkade-playground>` in JSX of Preact: `import type {} from "parkade/element/preact"`. */
import type { HTMLAttributes } from "preact";
import type { ParkadePlayground, PlaygroundAttributes } from "../element.js";

declare module "preact" {
  namespace JSX {
    interface IntrinsicElements {
      "parkade-playground": Omit<HTMLAttributes<ParkadePlayground>, keyof PlaygroundAttributes> & PlaygroundAttributes;
    }
  }
}
