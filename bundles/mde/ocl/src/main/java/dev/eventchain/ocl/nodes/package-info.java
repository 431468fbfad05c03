/**
 * Compiled expressions: immutable nodes that evaluate themselves in a run. Independent of the
 * parser and its environment.
 */
package dev.eventchain.ocl.nodes;
