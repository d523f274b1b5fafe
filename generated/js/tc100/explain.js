export * from "./v2_0_explain.js";
