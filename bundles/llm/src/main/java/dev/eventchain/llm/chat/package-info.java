/**
 * Requests to language models and their answers, with the schema of an answer and the key of a
 * request. Knows no way to get an answer.
 */
package dev.eventchain.llm.chat;
