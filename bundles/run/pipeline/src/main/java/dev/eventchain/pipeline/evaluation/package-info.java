/**
 * The comparison of language models by runs of one project: the runs, their grades, and the table,
 * page and JSON of the result. Runs the stages through the engine, and does not depend on exit
 * codes.
 */
package dev.eventchain.pipeline.evaluation;
