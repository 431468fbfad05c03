/**
 * Tests of components, and the checks of the Python code that a language model wrote. Knows the
 * description of the chain, and no prompt.
 */
package dev.eventchain.agents.component;
