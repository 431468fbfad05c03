/** What is known of the requirements of a project, and what a change of them does. */
package dev.eventchain.pipeline.requirements;
