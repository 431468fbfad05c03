/** Checks of event chains beyond OCL: message contracts and data flow. */
package dev.eventchain.contracts;
