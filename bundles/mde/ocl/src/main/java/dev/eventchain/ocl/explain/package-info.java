/**
 * Reasons why a condition is false, found by evaluating its parts. Independent of the parser and
 * the nodes.
 */
package dev.eventchain.ocl.explain;
