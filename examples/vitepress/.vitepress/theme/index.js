// Without the fonts that come late and move the text.
import theme from "vitepress/theme-without-fonts";
import "./parkade.css";

export default theme;
