/** Upper bounds on end-to-end latencies from periods and worst cases; no models, no files. */
package dev.eventchain.contracts.timing;
