import { pages } from "../.vitepress/planners";

export default { paths: () => pages("en") };
