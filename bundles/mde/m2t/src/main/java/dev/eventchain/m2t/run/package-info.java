/**
 * State of one generation: calls, cached values of queries, findings and files. Independent of
 * steps, templates and queries.
 */
package dev.eventchain.m2t.run;
