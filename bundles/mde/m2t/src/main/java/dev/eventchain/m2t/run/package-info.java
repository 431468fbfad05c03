/**
 * The state of one generation: calls, kept values of queries, findings and files. Knows no step,
 * template or query.
 */
package dev.eventchain.m2t.run;
