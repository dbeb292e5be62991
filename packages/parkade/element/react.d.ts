/** `<parkade-playground>` in JSX of React 19: `import type {} from "parkade/element/react"`. */
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { ParkadePlayground, PlaygroundAttributes } from "../element.js";

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "parkade-playground": Omit<
        DetailedHTMLProps<HTMLAttributes<ParkadePlayground>, ParkadePlayground>,
        keyof PlaygroundAttributes
      > &
        PlaygroundAttributes;
    }
  }
}
