// esbuild gathers imported style sheets into the bundle's CSS.
declare module "*.css";
