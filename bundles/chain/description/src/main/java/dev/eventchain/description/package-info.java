/**
 * Event-chain descriptions, the JSON of the paper's Appendix A: reader, writer and schema. Problems
 * are findings with the JSON pointer, line and column.
 */
package dev.eventchain.description;
