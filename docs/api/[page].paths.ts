import { reference } from "../.vitepress/reference";

export default { paths: () => [{ params: { page: "reference" }, content: reference() }] };
