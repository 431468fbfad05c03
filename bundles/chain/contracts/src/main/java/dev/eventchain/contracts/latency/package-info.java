/** Checks and bounds of end-to-end latencies before anything is simulated. */
package dev.eventchain.contracts.latency;
