/** Programs that print performance figures. */
package dev.eventchain.benchmarks;
