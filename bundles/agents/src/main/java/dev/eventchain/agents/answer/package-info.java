/**
 * The artefact in the text of an answer: code blocks, surrounding prose, and JSON read with
 * tolerance. Does not know what the artefact means.
 */
package dev.eventchain.agents.answer;
