/**
 * Extraction of the artefact from the text of an answer: code blocks, surrounding prose, and
 * lenient JSON. Independent of the meaning of the artefact.
 */
package dev.eventchain.agents.answer;
