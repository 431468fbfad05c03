/**
 * Descriptions of chains as language models write them, and the checks of a designed chain. Knows
 * no prompt and no model.
 */
package dev.eventchain.agents.chain;
