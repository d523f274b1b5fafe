export * from "./v1_explain.js";
