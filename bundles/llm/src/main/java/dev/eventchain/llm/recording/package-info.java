/**
 * Recorded conversations in the project's folder: written, found by the key of a request, and
 * replayed. Opens no connection.
 */
package dev.eventchain.llm.recording;
