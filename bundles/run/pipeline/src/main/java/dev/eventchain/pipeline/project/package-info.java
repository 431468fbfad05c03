/**
 * A user's folder together with its configuration: language models, template and facts of the
 * generated package. Knows no run.
 */
package dev.eventchain.pipeline.project;
