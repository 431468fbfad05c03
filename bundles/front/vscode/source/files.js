"use strict";
// Which files are about event chains, their constraints, templates and projects.

const EXTENSIONS = ["mtl", "ocl", "ecore", "xmi", "eventchain"];

/** Files of a project by their name; there are others of the same kind elsewhere. */
const PATTERNS = [
  `**/*.{${EXTENSIONS.join(",")}}`,
  "**/{eventchain,bench,faults,mutants,eventchain-suppressions}.yaml",
  "**/{scenarios,tests,campaigns}/**/*.{yaml,yml}",
  "**/{requirements,design-rules}.md",
  "**/{chain,components,signals,questions}.json",
];

/** What the language server is asked about. */
const SELECTOR = [
  ...["file", "untitled"].flatMap((scheme) => [
    { scheme, language: "mtl" },
    { scheme, language: "ocl" },
  ]),
  ...PATTERNS.map((pattern) => ({ scheme: "file", pattern })),
];

/** The file that makes a folder a project. */
const SETTINGS = "eventchain.yaml";

module.exports = { SELECTOR, SETTINGS };
