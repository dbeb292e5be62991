import theme from "vitepress/theme";
import "./parkade.css";

export default theme;
