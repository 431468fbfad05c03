/** Programs that print how fast something is. */
package dev.eventchain.benchmarks;
