/**
 * Checks of generated constraints: parsing, and the proof that a changed model can violate them.
 * Independent of prompts and chain descriptions.
 */
package dev.eventchain.agents.constraint;
