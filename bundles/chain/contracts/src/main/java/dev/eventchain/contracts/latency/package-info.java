/** What an event chain says about its end-to-end latencies before anything is simulated. */
package dev.eventchain.contracts.latency;
