/**
 * The results of stages as values, and their JSON in records and reports. Every key is written and
 * read here. Depends on no stage.
 */
package dev.eventchain.pipeline.results;
