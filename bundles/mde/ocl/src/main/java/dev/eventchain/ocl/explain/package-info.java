/**
 * Reasons why a condition is false, found by evaluating its parts. Knows neither the parser nor the
 * nodes.
 */
package dev.eventchain.ocl.explain;
