/**
 * Answers of a person, through files, and of a program that is started for each request.
 * Independent of services and their prices.
 */
package dev.eventchain.llm.handoff;
