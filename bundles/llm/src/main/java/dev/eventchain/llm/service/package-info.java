/**
 * Services over HTTP: where they are, what they cost, how each is spoken to, and what their
 * failures mean. Knows no recordings.
 */
package dev.eventchain.llm.service;
