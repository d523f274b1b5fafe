export * from "./v1_17_explain.js";
