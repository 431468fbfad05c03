/**
 * Event-chain descriptions, the JSON of the paper's Appendix A: read to models, written from
 * models, and the schema for them. Problems are findings with the JSON pointer, line and column.
 */
package dev.eventchain.description;
