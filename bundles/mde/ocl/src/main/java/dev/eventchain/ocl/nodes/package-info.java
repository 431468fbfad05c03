/**
 * Compiled expressions: immutable nodes that evaluate themselves in a run. Knows neither the parser
 * nor its environment.
 */
package dev.eventchain.ocl.nodes;
