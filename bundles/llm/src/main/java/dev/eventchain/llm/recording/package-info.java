/**
 * Recorded conversations in the project's folder: written, found by the key of a request, and
 * replayed. Opens no connections.
 */
package dev.eventchain.llm.recording;
