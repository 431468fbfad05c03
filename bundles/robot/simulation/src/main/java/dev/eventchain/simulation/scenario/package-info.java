/**
 * Scenarios as people write them: the situation, the inputs and the criteria, with their readers
 * and the rules that judge a trace. Knows no chain and nothing of how nodes are run.
 */
package dev.eventchain.simulation.scenario;
