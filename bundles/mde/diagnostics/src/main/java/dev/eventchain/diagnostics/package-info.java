/** Findings, their places, and what is read while some work is done. */
package dev.eventchain.diagnostics;
