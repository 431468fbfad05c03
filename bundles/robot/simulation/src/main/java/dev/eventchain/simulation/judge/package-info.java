/**
 * Verdicts of runs: criteria, faults and their detection, and the series and scenes that reports
 * show. Starts nothing.
 */
package dev.eventchain.simulation.judge;
