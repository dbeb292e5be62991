import "./element/playground";
