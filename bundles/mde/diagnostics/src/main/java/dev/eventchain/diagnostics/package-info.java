/** Findings, their locations, and the formats of reports. */
package dev.eventchain.diagnostics;
