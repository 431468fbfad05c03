/**
 * Requests to language models and their answers, with the schema of an answer and the key of a
 * request. Independent of the source of answers.
 */
package dev.eventchain.llm.chat;
