/**
 * Scenarios as written by users: the situation, the inputs and the criteria, with their readers and
 * the rules that judge a trace. Knows no chain and no running node.
 */
package dev.eventchain.simulation.scenario;
