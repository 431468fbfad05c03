/**
 * Services over HTTP: their addresses, prices, protocols and failures. Independent of recordings.
 */
package dev.eventchain.llm.service;
