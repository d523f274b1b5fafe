export * from "./v2_14_4_explain.js";
