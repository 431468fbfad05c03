/** Formats of reports: text, JSON, SARIF and JUnit XML. */
package dev.eventchain.diagnostics.format;
