/** Findings as values, the places they point to, and the formats they are written in. */
package dev.eventchain.diagnostics;
