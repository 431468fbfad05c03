/**
 * Generated constraints: whether they parse, and the proof that a changed model can violate them.
 * Knows no prompt and no chain description.
 */
package dev.eventchain.agents.constraint;
