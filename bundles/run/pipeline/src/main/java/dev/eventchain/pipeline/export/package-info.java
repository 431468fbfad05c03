/** The scenarios of a project in the formats of other players. */
package dev.eventchain.pipeline.export;
